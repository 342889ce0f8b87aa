//! The variant as one JSON object: what tools and courses keep.

use serde_json::Map;
use serde_json::Value;
use serde_json::json;

use momentous_explain as explain;
use momentous_grade::Report;
use momentous_problem::End;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_render::Identity;
use momentous_solve::Bounded;

use super::Exercise;

/// The fields that make the same variant again, as the first of a record.
fn named(identity: &Identity) -> Map<String, Value> {
    let fields = [
        ("problem", json!(identity.problem)),
        ("digest", json!(identity.digest)),
        ("scheme", json!(identity.scheme)),
        ("seed", json!(identity.seed)),
        ("form", json!(identity.form)),
    ];
    fields.into_iter().map(|(key, value)| (key.to_owned(), value)).collect()
}

impl Exercise {
    /// The variant as one JSON object with stable keys.
    #[must_use]
    pub fn record(&self, solution: Option<String>) -> Value {
        let worked = self.worked();
        let identity = self.identity();
        let given: Map<String, Value> = self
            .variant
            .all_given()
            .iter()
            .filter(|(symbol, ..)| !self.problem.model().literals.iter().any(|(literal, _)| literal == symbol))
            .map(|(symbol, value, unit)| {
                let name = self.problem.model().symbols.entry(*symbol).name.clone();
                // Of what is told by its symbol only, the value is no part of the question.
                let value = (!worked.form.free.contains(symbol)).then(|| value.to_string());
                (name, json!({ "value": value, "unit": unit.to_string() }))
            })
            .collect();
        let ask: Vec<Value> = worked.form.parts.iter().map(|part| self.asked(part)).collect();
        let mut record = named(&identity);
        record.insert("text".into(), Value::String(self.variant.text(&self.problem)));
        record.insert("given".into(), Value::Object(given));
        record.insert("ask".into(), Value::Array(ask));
        if let Some(mark) = identity.secret {
            record.insert("secret".into(), Value::String(mark));
        }
        if let Some(solution) = solution {
            record.insert("solution".into(), Value::String(solution));
            record.insert("lines".into(), json!(explain::lines(worked)));
        }
        Value::Object(record)
    }

    /// A report on answers to the variant as one JSON object, with what makes the same variant again.
    ///
    /// # Errors
    /// None that is known: a report is made of texts and numbers.
    pub fn mark_record(&self, report: &Report) -> serde_json::Result<Value> {
        let mut record = named(&self.identity());
        if let Value::Object(report) = serde_json::to_value(report)? {
            record.extend(report);
        }
        Ok(Value::Object(record))
    }

    fn asked(&self, part: &Part) -> Value {
        match &part.kind {
            PartKind::Number(number) => {
                let answer = self.worked().answer(number);
                let all: Vec<f64> = self.worked().answers(number).iter().map(|answer| answer.or_zero()).collect();
                let unit = self.problem.unit_name(number);
                let mut asked = json!({
                    "id": part.id,
                    "kind": if number.whole { "count" } else { "number" },
                    "find": self.problem.model().symbols.entry(number.symbol).name,
                    "value": answer.or_zero(),
                    "unit": unit,
                    "printed": self.printed(part),
                    "error_bound": answer.error.is_finite().then_some(answer.error),
                    "points": part.points,
                });
                if let (true, Some(object)) = (all.len() > 1, asked.as_object_mut()) {
                    object.insert("values".into(), json!(all));
                }
                asked
            }
            PartKind::Vector(vector) => {
                let answers: Vec<Bounded> =
                    vector.components.iter().map(|number| self.worked().answer(number)).collect();
                let bounds: Vec<_> =
                    answers.iter().map(|answer| answer.error.is_finite().then_some(answer.error)).collect();
                json!({
                    "id": part.id,
                    "kind": "vector",
                    "find": part.id,
                    "axes": vector.axes,
                    "value": answers.iter().map(|answer| answer.or_zero()).collect::<Vec<_>>(),
                    "unit": vector.components.first().map(|answer| self.problem.unit_name(answer)),
                    "printed": self.printed(part),
                    "error_bound": bounds,
                    "points": part.points,
                })
            }
            PartKind::Formula(formula) => self.formula_record(part, formula),
            PartKind::Range(range) => {
                let interval = self.worked().interval(range);
                let end = |end: Option<End>| {
                    end.map(
                        |end| json!({ "value": end.value.or_zero(), "closed": end.closed, "limit_of_quantity": end.is_limit }),
                    )
                };
                json!({
                    "id": part.id,
                    "kind": "interval",
                    "find": part.label,
                    "low": interval.as_ref().and_then(|ends| end(ends.low)),
                    "high": interval.as_ref().and_then(|ends| end(ends.high)),
                    "unit": self.problem.unit_name(&range.number),
                    "printed": self.printed(part),
                    "points": part.points,
                })
            }
            PartKind::Choice(choice) => {
                let decision = choice.decided(&self.worked());
                let mut asked = json!({
                    "id": part.id,
                    "kind": "choice",
                    "find": part.label,
                    "options": decision.options,
                    "value": decision.options.get(decision.right),
                    "because": decision.because,
                    "points": part.points,
                });
                // In words: what a screen reader says of each.
                let pictures: Vec<String> =
                    self.pictures(part).into_iter().map(|drawing| drawing.description).collect();
                if let (false, Some(object)) = (pictures.is_empty(), asked.as_object_mut()) {
                    object.insert("pictures".into(), json!(pictures));
                }
                asked
            }
        }
    }
}
