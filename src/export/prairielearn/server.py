def generate(data):
    """Picks the variant that belongs to the seed."""
    variant = json.loads(VARIANTS[int(data["variant_seed"]) % len(VARIANTS)])
    data["params"].update(variant)
    for field in variant["fields"]:
        if "right" in field:
            data["correct_answers"][field["name"]] = field["right"]


def found(field, given):
    """What an answer earns, from 0 to 1, and what is said of it."""
    if "options" in field:
        place = ord(given) - ord("a") if isinstance(given, str) and len(given) == 1 else -1
        chosen = field["options"][place] if 0 <= place < len(field["options"]) else None
        return (1 if chosen["right"] == "true" else 0, chosen["feedback"]) if chosen else (0, "")
    if not isinstance(given, (int, float)):
        return 0, ""
    for low, high, share, feedback in field["windows"]:
        if low <= given <= high:
            return share, feedback
    return 0, ""


def grade(data):
    """Marks each field by its windows, which know more than a tolerance."""
    said, earned, whole = [], 0, 0
    for field in data["params"]["fields"]:
        name = field["name"]
        share, feedback = found(field, data["submitted_answers"].get(name))
        partial = data["partial_scores"].setdefault(name, {})
        partial["score"], partial["weight"] = share, field["weight"]
        earned, whole = earned + share * field["weight"], whole + field["weight"]
        if feedback:
            said.append({"name": name, "html": feedback})
    data["feedback"]["said"] = said
    data["score"] = earned / whole if whole else 0
