//! A proxy before PostgreSQL that cuts a connection at a call.

use std::sync::{Arc, Mutex};

use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::{TcpListener, TcpStream};

/// Where in a call the connection is cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moment {
    /// Before the database hears of it.
    Before,
    /// When the database has heard the first half.
    Within,
    /// When the database has done it, before the answer arrives.
    After,
}

/// A proxy before PostgreSQL.
pub struct Proxy {
    /// The address of the database through it.
    pub url: String,
    plan: Arc<Mutex<Option<Plan>>>,
}

/// The calls before the one at which a connection is cut, once.
struct Plan {
    before: usize,
    moment: Moment,
}

impl Proxy {
    /// A proxy before the database at an address.
    pub async fn before(url: &str) -> Self {
        let (start, rest) = url.split_once("://").unwrap();
        let (authority, path) = rest.split_once('/').unwrap();
        let (user, host) = authority.rsplit_once('@').map_or(("", authority), |(user, host)| (user, host));
        let host = if host.contains(':') { host.to_owned() } else { format!("{host}:5432") };
        let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
        let address = listener.local_addr().unwrap();
        let url = format!("{start}://{user}{}{address}/{path}", if user.is_empty() { "" } else { "@" });
        let plan = Arc::new(Mutex::new(None));
        tokio::spawn(serve(listener, host, Arc::clone(&plan)));
        Self { url, plan }
    }

    /// Cuts whichever connection makes the call after so many others.
    pub fn cut(&self, before: usize, moment: Moment) {
        *self.plan.lock().unwrap() = Some(Plan { before, moment });
    }

    /// Whether a connection was cut since it was said so; from now on none is.
    pub fn has_cut(&self) -> bool {
        self.plan.lock().unwrap().take().is_none()
    }
}

async fn serve(listener: TcpListener, host: String, plan: Arc<Mutex<Option<Plan>>>) {
    while let Ok((client, _)) = listener.accept().await {
        let (host, plan) = (host.clone(), Arc::clone(&plan));
        tokio::spawn(async move {
            let server = TcpStream::connect(host).await.unwrap();
            // Whichever side has gone, the other is told by the end of its connection.
            let _ = pass(client, server, &plan).await;
        });
    }
}

/// Whether a connection is cut at the call that comes now.
fn now(plan: &Mutex<Option<Plan>>) -> Option<Moment> {
    let mut plan = plan.lock().unwrap();
    let Plan { before, moment } = plan.as_mut()?;
    if *before > 0 {
        *before -= 1;
        return None;
    }
    let moment = *moment;
    *plan = None;
    Some(moment)
}

/// Passes on what both sides say; what a client sends at once is a call.
async fn pass(mut client: TcpStream, mut server: TcpStream, plan: &Mutex<Option<Plan>>) -> std::io::Result<()> {
    let (mut asked, mut answered) = (vec![0; 1 << 16], vec![0; 1 << 16]);
    loop {
        tokio::select! {
            count = client.read(&mut asked) => {
                let count = count?;
                if count == 0 {
                    return Ok(());
                }
                match now(plan) {
                    None => server.write_all(&asked[..count]).await?,
                    Some(Moment::Before) => return Ok(()),
                    Some(Moment::Within) => return server.write_all(&asked[..count / 2]).await,
                    Some(Moment::After) => {
                        server.write_all(&asked[..count]).await?;
                        // However much it answers, nobody hears it.
                        let _ = server.read(&mut answered).await?;
                        return Ok(());
                    }
                }
            }
            count = server.read(&mut answered) => {
                let count = count?;
                if count == 0 {
                    return Ok(());
                }
                client.write_all(&answered[..count]).await?;
            }
        }
    }
}
