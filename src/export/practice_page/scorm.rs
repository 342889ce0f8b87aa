//! The manifest of a package of SCORM 1.2: one item, the page.

use crate::element::{VERBATIM, element};

/// The names of the package's only organization, item and resource.
const ORGANIZATION: &str = "organization";
const ITEM: &str = "item";
const RESOURCE: &str = "page";

/// The manifest of a page with that title, and of the file beside it; `identifier` tells it from others of the platform.
pub(super) fn manifest(title: &str, identifier: &str, page: &str, beside: &str) -> String {
    let file = |name: &str| element("file").with("href", name);
    let metadata =
        element("metadata").holding(element("schema").text("ADL SCORM")).holding(element("schemaversion").text("1.2"));
    let item =
        element("item").with("identifier", ITEM).with("identifierref", RESOURCE).holding(element("title").text(title));
    let organization =
        element("organization").with("identifier", ORGANIZATION).holding(element("title").text(title)).holding(item);
    let resource = element("resource")
        .with("identifier", RESOURCE)
        .with("type", "webcontent")
        .with("adlcp:scormtype", "sco")
        .with("href", page)
        .holding_all([page, beside].map(file));
    element("manifest")
        .with("identifier", identifier)
        .with("version", "1.0")
        .with("xmlns", "http://www.imsproject.org/xsd/imscp_rootv1p1p2")
        .with("xmlns:adlcp", "http://www.adlnet.org/xsd/adlcp_rootv1p2")
        .holding(metadata)
        .holding(element("organizations").with("default", ORGANIZATION).holding(organization))
        .holding(element("resources").holding(resource))
        .document(VERBATIM)
}
