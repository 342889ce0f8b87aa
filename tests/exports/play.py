"""Answers questions as PrairieLearn does: draws the variant of the seed, then marks one field."""
import json
import sys

servers = {}
marked = []
for form, seed, name, answer in json.load(sys.stdin):
    if form not in servers:
        servers[form] = {}
        exec(open(form + ".py", encoding="utf-8").read(), servers[form])
    server = servers[form]
    data = {"variant_seed": seed, "params": {}, "correct_answers": {}, "feedback": {}, "score": 0}
    server["generate"](data)
    data = json.loads(json.dumps(data))
    fields = {field["name"]: field for field in data["params"]["fields"]}
    assert all(("right" in field) == (key in data["correct_answers"]) for key, field in fields.items())
    data["submitted_answers"] = {name: answer}
    data["partial_scores"] = {key: {"score": 0, "weight": field["weight"]} for key, field in fields.items()}
    server["grade"](data)
    whole = sum(field["weight"] for field in fields.values())
    share = data["partial_scores"][name]["score"]
    assert abs(data["score"] - share * fields[name]["weight"] / whole) < 1e-12
    said = "".join(own["html"] for own in data["feedback"]["said"] if own["name"] == name)
    options = "".join(option["html"] for option in fields[name].get("options", []))
    marked.append([share, said, options])
json.dump(marked, sys.stdout)
