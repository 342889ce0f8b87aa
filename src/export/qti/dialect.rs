//! QTI 3.0 and 2.1: the same elements, spelt differently.

use std::borrow::Cow;

use super::super::element::Spelling;

/// One of the versions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dialect {
    pub spelling: Spelling,
    /// The namespace of items and tests.
    pub namespace: &'static str,
    /// The namespace of the manifest.
    pub manifest: &'static str,
    /// The name of the manifest's schema, and its version.
    pub schema: [&'static str; 2],
    /// The ending of types of resources.
    pub resource: &'static str,
    /// Whether what feedback holds stands in an element of its own.
    pub has_content_body: bool,
}

/// QTI 3.0.
pub(super) const QTI_3: Dialect = Dialect {
    spelling: Spelling { element: |name| format!("qti-{name}").into(), attribute: |name| name.into() },
    namespace: "http://www.imsglobal.org/xsd/imsqtiasi_v3p0",
    manifest: "http://www.imsglobal.org/xsd/qti/qtiv3p0/imscp_v1p1",
    schema: ["QTI Package", "3.0.0"],
    resource: "xmlv3p0",
    has_content_body: true,
};

/// QTI 2.1.
pub(super) const QTI_2: Dialect = Dialect {
    spelling: Spelling { element: camel_case, attribute: camel_case },
    namespace: "http://www.imsglobal.org/xsd/imsqti_v2p1",
    manifest: "http://www.imsglobal.org/xsd/imscp_v1p1",
    schema: ["QTIv2.1 Package", "1.0.0"],
    resource: "xmlv2p1",
    has_content_body: false,
};

/// `base-type` as `baseType`.
fn camel_case(name: &str) -> Cow<'_, str> {
    if !name.contains('-') {
        return name.into();
    }
    let mut pieces = name.split('-');
    let first = pieces.next().unwrap_or_default().to_owned();
    let capital = |piece: &str| {
        let mut letters = piece.chars();
        letters.next().map(|letter| letter.to_ascii_uppercase()).into_iter().chain(letters).collect::<String>()
    };
    pieces.fold(first, |name, piece| name + &capital(piece)).into()
}

#[cfg(test)]
mod tests {
    use super::camel_case;

    #[test]
    fn names_of_the_older_version_have_capitals() {
        assert_eq!(["value", "response-else-if"].map(camel_case), ["value", "responseElseIf"]);
    }
}
