//! `gks viewer`: shows the window of a program, which started it and talks to it through its standard input
//! and output.

mod picture;
mod window;

use crate::commands::Failure;
use gks_workstations::interactive::protocol::{Answer, Order};
use std::io::{self, BufReader, Write};
use std::process::ExitCode;
use std::thread;
use window::{Message, Window};
use winit::event_loop::EventLoop;

/// Shows a window until the program or the operator closes it.
pub fn run() -> Result<ExitCode, Failure> {
    let mut input = BufReader::with_capacity(1 << 16, io::stdin());
    let Some(Order::Open(width, height, title)) = Order::read(&mut input, None)? else {
        return Err("gks viewer is started by programs that open windows".into());
    };
    let event_loop = match EventLoop::<Message>::with_user_event().build() {
        Ok(event_loop) => event_loop,
        Err(error) => {
            let mut output = io::stdout();
            Answer::Refused(error.to_string()).write(&mut output)?;
            output.flush()?;
            return Ok(ExitCode::FAILURE);
        }
    };
    let proxy = event_loop.create_proxy();
    thread::spawn(move || {
        let size = Some((width, height));
        while let Ok(Some(order)) = Order::read(&mut input, size) {
            if proxy.send_event(Message::Order(order)).is_err() {
                return;
            }
        }
        // An event loop that has ended needs no message.
        let _ = proxy.send_event(Message::End);
    });
    event_loop.run_app(&mut Window::new(&title, width, height))?;
    Ok(ExitCode::SUCCESS)
}
