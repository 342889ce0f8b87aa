//! A cache beside a form, for what a later room works out of it.

use std::any::Any;
use std::fmt;
use std::sync::Arc;
use std::sync::OnceLock;

/// Values that a later room works out of a form once, for all its variants. Only that room knows the type.
#[derive(Clone, Default)]
pub struct FormCache(OnceLock<Arc<dyn Any + Send + Sync>>);

impl FormCache {
    /// Returns the kept value, made when it is first wanted.
    pub fn get<T: Any + Send + Sync>(&self, make: impl Fn() -> T) -> Arc<T> {
        let kept = self.0.get_or_init(|| Arc::new(make()));
        // A second room that kept something else would have to make it each time.
        Arc::clone(kept).downcast().unwrap_or_else(|_| Arc::new(make()))
    }
}

impl fmt::Debug for FormCache {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_tuple("FormCache").field(&self.0.get().is_some()).finish()
    }
}
