//! A server on an address, until it is told to stop.

use std::error::Error;
use std::io;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use tokio::net::{TcpListener, TcpSocket};
use tokio::runtime::Builder;

use momentous_fault::Faults;

use super::app::App;
use super::companion::Companion;
use super::connections;
use super::metrics_page::metrics_router;
use super::routes::router;
use super::settings::Settings;

/// Why nothing is served.
#[derive(Debug, thiserror::Error)]
pub enum NotServed {
    /// A bank or a template is at fault.
    #[error(transparent)]
    Faults(#[from] Faults),
    /// The address cannot be used.
    #[error("{0} cannot be used: {1}")]
    Address(SocketAddr, io::Error),
    /// The data of courses cannot be used.
    #[error(transparent)]
    Data(Box<dyn Error + Send + Sync>),
    /// The server cannot start, or broke off.
    #[error("the server cannot go on: {0}")]
    Broken(#[from] io::Error),
}

/// How long work that nobody waits for any more may hold the end up.
const ENDING: Duration = Duration::from_secs(2);

/// The number of connections that may wait until they are taken. Whoever finds no room there is let in a second later, when the
/// system tries again.
const WAITING: u32 = 4096;

/// Serves until the program is told to stop (Ctrl-C, or SIGTERM); requests under way are answered first, those of fifteen seconds.
/// `companion` opens what is served beside the pages of problems, once the address is taken; `ready` hears the address then.
///
/// # Errors
/// Where the bank or a template cannot be read, or the address is taken.
pub fn serve(
    settings: Settings,
    companion: impl Future<Output = Result<Option<Arc<dyn Companion>>, NotServed>>,
    ready: impl FnOnce(SocketAddr),
) -> Result<(), NotServed> {
    let (bind, metrics) = (settings.bind, settings.metrics);
    let mut app = App::new(settings)?;
    let runtime = Builder::new_multi_thread().enable_all().build()?;
    let served = runtime.block_on(async {
        let listener = listening(bind)?;
        let address = listener.local_addr()?;
        app.settings.bind = address;
        if let Some(companion) = companion.await? {
            app = app.with_companion(companion);
        }
        let app = Arc::new(app);
        if let Some(address) = metrics {
            let (listener, page) = (listening(address)?, metrics_router(Arc::clone(&app)));
            tokio::spawn(async move { axum::serve(listener, page).await });
        }
        // Whoever hears the address may tell it to stop.
        let stop = told_to_stop()?;
        ready(address);
        connections::serve(listener, router(app), stop).await;
        Ok(())
    });
    runtime.shutdown_timeout(ENDING);
    served
}

fn listening(address: SocketAddr) -> Result<TcpListener, NotServed> {
    let listen = || {
        let socket = if address.is_ipv4() { TcpSocket::new_v4()? } else { TcpSocket::new_v6()? };
        // Connections of a server that has just ended keep nobody from its address. Elsewhere this would let two servers share it.
        #[cfg(unix)]
        socket.set_reuseaddr(true)?;
        socket.bind(address)?;
        socket.listen(WAITING)
    };
    listen().map_err(|error| NotServed::Address(address, error))
}

/// From now on the program waits to be told to stop; the future ends when it is.
#[cfg(unix)]
fn told_to_stop() -> io::Result<impl Future<Output = ()>> {
    use std::future::poll_fn;
    use std::task::Poll;

    use tokio::signal::unix::{SignalKind, signal};

    let (mut interrupted, mut terminated) = (signal(SignalKind::interrupt())?, signal(SignalKind::terminate())?);
    Ok(poll_fn(move |context| {
        let is_told = interrupted.poll_recv(context).is_ready() || terminated.poll_recv(context).is_ready();
        if is_told { Poll::Ready(()) } else { Poll::Pending }
    }))
}

#[cfg(not(unix))]
fn told_to_stop() -> io::Result<impl Future<Output = ()>> {
    Ok(async {
        let _ = tokio::signal::ctrl_c().await;
    })
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    #[test]
    fn hundreds_who_come_at_once_wait_to_be_taken() {
        let runtime = Builder::new_current_thread().enable_all().build().unwrap();
        let _within = runtime.enter();
        let listener = listening(([127, 0, 0, 1], 0).into()).unwrap();
        let address = listener.local_addr().unwrap();
        // Nobody takes them meanwhile.
        let connect = |_| std::net::TcpStream::connect_timeout(&address, Duration::from_millis(900));
        let connected: Result<Vec<_>, _> = (0..500).map(connect).collect();
        assert_eq!(connected.map(|all| all.len()).ok(), Some(500));
    }
}
