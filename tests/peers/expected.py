"""Robots that frs must refuse as they stand, and what is compared after that."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Expected:
    """`words`: the refusal contains them. Then `--lenient`, a repaired copy, or nothing at all is compared."""

    words: str
    lenient: bool = False
    without_products: tuple = ()  # links whose products of inertia are taken away in the copy

    @property
    def comparable(self):
        return self.lenient or bool(self.without_products)


# A moment of inertia larger than the sum of the other two is the one thing that --lenient reads.
FLAT = Expected("expected the largest to be at most the sum of the other two", lenient=True)
# A negative moment is beyond --lenient.
ANTENNAS = Expected(
    "expected moments that are not negative",
    without_products=("base_antenna_left_link", "base_antenna_right_link"),
)

REFUSALS = {
    "alex/alex_psyonic_hands": Expected("mimic of joint 'index_q1'"),  # fingers follow a joint that does not exist
    "allegro_hand/allegro_left_hand": FLAT,
    "allegro_hand/allegro_right_hand": FLAT,
    "anymal_b_simple/anymal": FLAT,
    "anymal_b_simple/anymal-kinova": FLAT,
    "anymal_c_simple/anymal": FLAT,
    "b1/b1": FLAT,
    "b1/b1-z1": FLAT,
    "go1/go1": FLAT,
    "hyq/hyq_no_sensors": FLAT,
    "pr2/pr2": FLAT,
    "romeo/romeo": Expected("joint 'LHand': nothing beyond the joint"),  # movable hands without mass
    "romeo/romeo_laas_small": Expected("joint 'l_gripper_joint': nothing beyond the joint"),  # movable grippers without mass
    "romeo/romeo_small": FLAT,
    "tiago/tiago": ANTENNAS,
    "tiago/tiago_dual": ANTENNAS,
    "tiago/tiago_no_hand": ANTENNAS,
    "tests/coaxial": Expected("nothing resists the joint's motion"),
    "ur/ur3": Expected("no link"),  # an empty robot element
}
