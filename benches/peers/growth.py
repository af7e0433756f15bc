"""How time grows with the number of joints."""

SHOWN = [
    ("pinocchio", "forward"), ("core", "forward"), ("generated", "forward"), ("pinocchio", "matrices"), ("core", "matrices"),
    ("generated", "matrices"), ("core", "position_sweep"),
]


def per_joint(chain, contestant, work):
    time = chain.time(contestant, work)
    return None if time is None else time / chain.n


def rows(chains):
    cells = lambda chain: ("–" if value is None else f"{value:.0f}" for value in (per_joint(chain, *one) for one in SHOWN))
    return ["n", *(f"{one}, {work}" for one, work in SHOWN)], [[str(chain.n), *cells(chain)] for chain in chains]
