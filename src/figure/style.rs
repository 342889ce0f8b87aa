//! One table for both writers: what each role looks like.

use super::Role;

/// Size of the type on drawings, in drawing units.
pub(super) const TYPE_SIZE: f64 = 11.0;

/// The look of a role.
pub(super) struct Style {
    /// Its name in CSS classes.
    pub class: &'static str,
    /// Colour in SVG. The coloured ones have a luminance near 0.18, which stands out equally on white and on near-black.
    pub colour: &'static str,
    /// A lighter one for dark pages, where the reader's program knows of them.
    pub dark: &'static str,
    /// The same as a mix for LaTeX's xcolor.
    pub mix: &'static str,
    /// Line width.
    pub width: f64,
    /// How strongly outlines and areas are filled with their colour, from 0 to 1.
    pub fill: f64,
}

const INK: (&str, &str) = ("currentColor", "currentColor");

/// The look of `role`.
pub(super) fn style(role: Role) -> Style {
    let (class, colours, mix, width, fill) = match role {
        Role::Body => ("body", INK, "black", 1.0, 0.07),
        Role::Momentum => ("momentum", ("#2878c8", "#74b4f0"), "blue!75!black", 1.6, 0.0),
        Role::Impulse => ("impulse", ("#c8501e", "#f0935f"), "red!75!black", 1.6, 0.16),
        Role::Velocity => ("velocity", ("#238551", "#5cc48c"), "green!45!black", 1.6, 0.0),
        Role::Force => ("force", ("#a84fc0", "#d297e4"), "violet!85!black", 1.6, 0.0),
        Role::Length => ("length", INK, "black", 0.9, 0.0),
        Role::Surface => ("surface", INK, "black", 1.2, 0.0),
        Role::Axis => ("axis", INK, "black", 0.7, 0.0),
        Role::Path => ("path", INK, "black!65", 0.8, 0.0),
        Role::Curve => ("curve", ("#a84fc0", "#d297e4"), "violet!85!black", 1.5, 0.12),
        Role::Guide => ("guide", INK, "black!55", 0.5, 0.0),
    };
    let (colour, dark) = colours;
    Style { class, colour, dark, mix, width, fill }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance of `#rrggbb`, as WCAG 2 defines it.
    fn luminance(colour: &str) -> Option<f64> {
        let digits = colour.strip_prefix('#')?;
        let channel = |at: usize| {
            let value = f64::from(u8::from_str_radix(digits.get(at..at + 2)?, 16).ok()?) / 255.0;
            Some(if value <= 0.039_28 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) })
        };
        Some(0.2126 * channel(0)? + 0.7152 * channel(2)? + 0.0722 * channel(4)?)
    }

    #[test]
    fn coloured_roles_stand_out_on_light_and_on_dark_pages() {
        for luminance in Role::ALL.iter().filter_map(|role| luminance(style(*role).colour)) {
            assert!(1.05 / (luminance + 0.05) > 3.8, "too pale on white");
            assert!((luminance + 0.05) / 0.057 > 3.8, "too dark on near-black");
        }
        for luminance in Role::ALL.iter().filter_map(|role| luminance(style(*role).dark)) {
            assert!((luminance + 0.05) / 0.057 > 7.0, "too dark for a dark page");
        }
    }
}
