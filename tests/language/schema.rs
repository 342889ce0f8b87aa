//! The schema of problem files: complete, and of one mind with the loader.

use std::path::Path;

use insta::glob;
use momentous::fault::Source;
use momentous::problem::{json_schema, load};
use serde_json::Value;

/// Faults that no schema can see: of YAML's form, of meaning, or of what one key says about another.
const BEYOND_A_SCHEMA: &[&str] = &[
    "yaml_",
    "placeholder_",
    "given_",
    "key_twice",
    "ask_beside_forms",
    "nothing_asked",
    "asked_twice",
    "graph_",
    "pieces_shorter",
    "angle_",
    "angles_",
    "angular_velocity_in_hertz",
    "hundredfold_in_per_cent",
    "any_without_a_unit",
    "conserved_about_nowhere",
    "conserved_while_sand_leaves",
    "conserved_without_stages",
    "energy_that_",
    "mass_that_a_burn_",
    "mass_that_changes_",
    "kind_undecided",
    "direction_of_a_mass",
    "division_by_zero",
    "expression_",
    "find_of_a_given",
    "force_",
    "friction_",
    "moment_on_a_rotor_",
    "place_and_slope_of_several",
    "push_of_",
    "motion_of_a_coefficient",
    "number_beyond_all",
    "plastic_beside_restitution",
    "range_of_what_does_not_matter",
    "require_that_never_holds",
    "revealed_and_asked",
    "slack_cord",
    "slide_back_",
    "slide_down_",
    "slide_on_",
    "slide_without_friction",
    "together_",
    "stages_of_one_name",
    "tower_of_powers",
    "unit_of_a_pure_number",
    "several_solutions",
    "unit_that_is_zero",
    "unknown_unit_asked",
    "instants_too_many",
    "instant_with_",
    "union_with_a_digit",
    "empty_ask",
    "holds_",
    "order_twice",
    "other_values_",
    "range_beside",
    "order_of_unlike",
    "yes_for_text",
    "yes_for_a_value",
    "incline_without_a_side",
    "rest_of_guided_bodies",
    "rotor_",
    "height_without_a_drop",
    "over_a_distance",
    "spring_without_a_body",
    "swing_",
    "conditions_without_dimension",
    "fixed_values_untold",
    "key_in_two_words",
    "name_of_the_scene",
    "weight_",
    "enough_",
    "only_one_option",
    "option_",
    "options_",
    "comparison_",
    "direction_of_what_is_no_component",
    "hint_",
    "text_that_prints",
    "pictures_",
    "resistance_",
    "rest_that_never_comes",
    "no_known_method",
    "potential_energy_without_a_spring",
    "magnitude_along_a_line",
    "ratio_without_its_parts",
    "stream_that_brings_nothing",
    "condition_of_equality",
    "duration_called",
    "fall_along",
    "flight_without_weight",
    "force_of_unlike",
    "formula_of_what",
    "fraction_without",
    "graph_against",
    "greatest_distance",
    "impact_at_one",
    "impulse_of_which",
    "jerk_over",
    "mass_with_a_number",
    "reveal_of",
    "two_rotors",
    "vector_without",
    "weights_for",
];

fn is_valid(path: &Path) -> bool {
    let text = std::fs::read_to_string(path).unwrap();
    let value: Value = serde_yaml::from_str(&text).unwrap_or_default();
    jsonschema::draft202012::is_valid(json_schema(), &value)
}

#[test]
fn an_independent_validator_accepts_what_the_loader_accepts() {
    for (folder, files) in [
        ("../fixtures/problems", "*.yaml"),
        ("../fixtures/golden", "*_*.yaml"),
        ("../fixtures/reference", "*-*.yaml"),
        ("../../problem_bank", "**/*.yaml"),
    ] {
        let mut seen = 0;
        glob!(folder, files, |path| {
            seen += 1;
            assert!(is_valid(path), "{}", path.display());
        });
        assert!(seen > 0, "{folder} has no problems");
    }
}

#[test]
fn an_independent_validator_refuses_the_same_files() {
    glob!("../fixtures/bad_problems", "*.yaml", |path| {
        let name = path.file_name().unwrap().to_str().unwrap();
        if !BEYOND_A_SCHEMA.iter().any(|prefix| name.starts_with(prefix)) {
            assert!(!is_valid(path), "{name}");
        }
    });
}

#[test]
fn every_key_has_a_description() {
    fn walk(schema: &Value, place: &str, bare: &mut Vec<String>) {
        let Value::Object(map) = schema else { return };
        for (name, property) in map.get("properties").and_then(Value::as_object).into_iter().flatten() {
            let place = format!("{place}.{name}");
            // A key that introduces a kind, as `impact:`, is described beside it.
            if property.get("description").or(map.get("description")).is_none() {
                bare.push(place.clone());
            }
            walk(property, &place, bare);
        }
        for part in ["$defs", "anyOf", "oneOf", "items", "additionalProperties"] {
            match map.get(part) {
                Some(Value::Array(schemas)) => schemas.iter().for_each(|schema| walk(schema, place, bare)),
                Some(Value::Object(schemas)) if part == "$defs" => {
                    schemas.iter().for_each(|(name, schema)| walk(schema, name, bare));
                }
                Some(schema) => walk(schema, place, bare),
                None => {}
            }
        }
    }
    let mut bare = Vec::new();
    walk(json_schema(), "", &mut bare);
    assert_eq!(bare, [""; 0]);
}

#[test]
fn decimals_stay_as_they_were_written() {
    for (written, kept) in
        [("0.7", "0.7"), ("0.70", "0.70"), ("1e3", "1e3"), (".5", ".5"), ("3 kg", "3 kg"), ("\"0.70\"", "0.70")]
    {
        let file = include_str!("../fixtures/problems/two_carts.yaml")
            .replace("restitution: e", &format!("restitution: {written}"))
            .replace("  e: { min: 0.3, max: 0.9, step: 0.05 }\n", &format!("  e: {written}\n"));
        let loaded = load(Source::new("a.yaml", &file)).unwrap();
        let momentous::scene::Stage::Impact(impact) = &loaded.draft.scene.stages[0] else { panic!("an impact") };
        assert_eq!(impact.restitution.as_ref().unwrap().0, kept);
        let momentous::problem::Given::Literal(literal) = loaded.given.get("e").unwrap() else { panic!("a value") };
        assert_eq!(literal.components[0].figures(), if kept == "0.70" { 2 } else { 1 });
    }
}
