//! The engine and its pages as a module of WebAssembly, for a file that needs no server.
//!
//! A browser knows numbers only, so texts cross by a buffer: [`reserve`] makes room for a request, [`answer`] answers it, and
//! [`answered_at`] says where the answer stands. Requests and answers are JSON, and [`Desk`] says which there are.

mod desk;

use std::cell::RefCell;

pub use desk::Desk;

thread_local! {
    /// A page has one thread.
    static SHARED: RefCell<(Desk, Vec<u8>)> = RefCell::new((Desk::default(), Vec::new()));
}

/// Makes room for a request of so many bytes; the address to which it is to be copied.
#[allow(unsafe_code, reason = "the name under which a browser finds it")]
#[unsafe(no_mangle)]
pub extern "C" fn reserve(length: usize) -> *mut u8 {
    SHARED.with_borrow_mut(|(_, buffer)| {
        buffer.clear();
        buffer.resize(length, 0);
        buffer.as_mut_ptr()
    })
}

/// Answers the request that was copied; the length of the answer in bytes.
#[allow(unsafe_code, reason = "the name under which a browser finds it")]
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> usize {
    SHARED.with_borrow_mut(|(desk, buffer)| {
        *buffer = desk.answer(buffer).into_bytes();
        buffer.len()
    })
}

/// The address of the answer.
#[allow(unsafe_code, reason = "the name under which a browser finds it")]
#[unsafe(no_mangle)]
pub extern "C" fn answered_at() -> *const u8 {
    SHARED.with_borrow(|(_, buffer)| buffer.as_ptr())
}
