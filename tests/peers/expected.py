"""Robots whose right answer is an error, by label, with the words that the message must contain."""

# Refused, and there is no number to compare.
REFUSED = {
    "alex/alex_psyonic_hands": "index_q1",  # fingers mimic a joint that does not exist
    "romeo/romeo": "LHand",  # a movable hand without mass
    "romeo/romeo_laas_small": "gripper",  # movable grippers without mass
    "ur/ur3": "link",  # an empty robot element
}

# Refused for an unphysical inertia; compared with --lenient, which accepts it.
LENIENT = {}
