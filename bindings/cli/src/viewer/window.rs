//! The window: draws the picture, and reports what the operator does in it.

use super::picture::{Picture, Placement};
use gks_workstations::interactive::event::{Button, Event, Key};
use gks_workstations::interactive::protocol::{Answer, Order};
use glam::DVec2;
use softbuffer::{Context, Surface};
use std::error::Error;
use std::io::{self, Write};
use std::num::NonZeroU32;
use std::rc::Rc;
use winit::application::ApplicationHandler;
use winit::dpi::LogicalSize;
use winit::event::{ElementState, MouseButton, MouseScrollDelta, WindowEvent};
use winit::event_loop::ActiveEventLoop;
use winit::keyboard::{Key as Symbol, ModifiersState, NamedKey};
use winit::window::{Window as Handle, WindowId};

/// How much of the screen a new window takes at most.
const SHARE: f64 = 0.9;
/// Pixels of a fine wheel that count as a notch.
const NOTCH: f64 = 40.0;

/// What arrives from the program.
pub(super) enum Message {
    /// An order.
    Order(Order),
    /// The program is gone.
    End,
}

type Shown = Surface<Rc<Handle>, Rc<Handle>>;

/// The viewer as the event loop drives it.
pub(super) struct Window {
    title: String,
    picture: Picture,
    window: Option<(Rc<Handle>, Shown)>,
    placement: Placement,
    pointer: DVec2,
    modifiers: ModifiersState,
    /// Whether the program is done and the window stays for the operator.
    kept: bool,
    output: io::Stdout,
}

impl Window {
    pub(super) fn new(title: &str, width: u32, height: u32) -> Window {
        let picture = Picture::new(width, height);
        let placement = picture.place(width, height);
        Window {
            title: if title.is_empty() { "GKS".to_owned() } else { format!("{title} - GKS") },
            picture,
            window: None,
            placement,
            pointer: DVec2::ZERO,
            modifiers: ModifiersState::empty(),
            kept: false,
            output: io::stdout(),
        }
    }

    fn open(&mut self, event_loop: &ActiveEventLoop) -> Result<(), Box<dyn Error>> {
        let (width, height) = self.picture.size();
        let (mut width, mut height) = (f64::from(width), f64::from(height));
        if let Some(monitor) = event_loop.primary_monitor().or_else(|| event_loop.available_monitors().next())
        {
            let room = monitor.size().to_logical::<f64>(monitor.scale_factor());
            let fit = (room.width * SHARE / width).min(room.height * SHARE / height);
            if fit > 0.0 && fit < 1.0 {
                (width, height) = (width * fit, height * fit);
            }
        }
        let attributes = Handle::default_attributes()
            .with_title(self.title.as_str())
            .with_inner_size(LogicalSize::new(width, height))
            .with_min_inner_size(LogicalSize::new(64.0, 64.0));
        let window = Rc::new(event_loop.create_window(attributes)?);
        let context = Context::new(Rc::clone(&window)).map_err(|error| error.to_string())?;
        let surface = Surface::new(&context, Rc::clone(&window)).map_err(|error| error.to_string())?;
        window.request_redraw();
        self.window = Some((window, surface));
        Ok(())
    }

    /// Tells the program something; a program that is gone ends the viewer through the order that never comes.
    fn answer(&mut self, answer: &Answer) {
        if !self.kept {
            let _ = answer.write(&mut self.output).and_then(|()| self.output.flush());
        }
    }

    fn report(&mut self, event: Event) {
        self.answer(&Answer::Event(event));
    }

    fn redraw(&mut self) -> Result<(), Box<dyn Error>> {
        let Some((window, surface)) = &mut self.window else { return Ok(()) };
        let size = window.inner_size();
        let (Some(width), Some(height)) = (NonZeroU32::new(size.width), NonZeroU32::new(size.height)) else {
            return Ok(());
        };
        surface.resize(width, height).map_err(|error| error.to_string())?;
        self.placement = self.picture.place(size.width, size.height);
        let mut buffer = surface.buffer_mut().map_err(|error| error.to_string())?;
        self.picture.draw(&self.placement, size.width, &mut buffer);
        window.pre_present_notify();
        buffer.present().map_err(|error| error.to_string())?;
        Ok(())
    }

    fn key(&mut self, event_loop: &ActiveEventLoop, symbol: &Symbol) {
        if self.kept {
            let quits = matches!(symbol, Symbol::Named(NamedKey::Escape))
                || matches!(symbol, Symbol::Character(text) if text == "q");
            if quits {
                event_loop.exit();
            }
            return;
        }
        match symbol {
            Symbol::Named(NamedKey::Space) => self.report(Event::Character(' ')),
            Symbol::Named(named) => {
                if let Some(key) = key(*named) {
                    self.report(Event::Key(key));
                }
            }
            Symbol::Character(_) if self.modifiers.control_key() || self.modifiers.super_key() => {}
            Symbol::Character(text) => text.chars().for_each(|c| self.report(Event::Character(c))),
            _ => {}
        }
    }
}

impl ApplicationHandler<Message> for Window {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.window.is_some() {
            return;
        }
        let answer = match self.open(event_loop) {
            Ok(()) => Answer::Ready,
            Err(error) => {
                event_loop.exit();
                Answer::Refused(error.to_string())
            }
        };
        self.answer(&answer);
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, message: Message) {
        match message {
            Message::Order(Order::Paint(area, pixels)) => {
                self.picture.paint(area, &pixels);
                if let Some((window, _)) = &self.window {
                    window.request_redraw();
                }
            }
            Message::Order(Order::Keep) => self.kept = true,
            Message::Order(Order::Close) => event_loop.exit(),
            Message::End if !self.kept => event_loop.exit(),
            Message::Order(Order::Open(..)) | Message::End => {}
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested => {
                self.report(Event::Closed);
                event_loop.exit();
            }
            WindowEvent::RedrawRequested => {
                if let Err(error) = self.redraw() {
                    eprintln!("gks viewer: {error}");
                    event_loop.exit();
                }
            }
            WindowEvent::Resized(_) | WindowEvent::ScaleFactorChanged { .. } => {
                if let Some((window, _)) = &self.window {
                    window.request_redraw();
                }
            }
            WindowEvent::ModifiersChanged(modifiers) => self.modifiers = modifiers.state(),
            WindowEvent::CursorMoved { position, .. } => {
                // The middle of the pixel that the pointer is on.
                self.pointer =
                    self.placement.to_picture(position.x.floor() + 0.5, position.y.floor() + 0.5).into();
                self.report(Event::Moved(self.pointer));
            }
            WindowEvent::MouseInput { state, button, .. } => {
                let button = match button {
                    MouseButton::Left => Button::Primary,
                    MouseButton::Middle => Button::Middle,
                    MouseButton::Right => Button::Secondary,
                    _ => return,
                };
                self.report(match state {
                    ElementState::Pressed => Event::Pressed(button, self.pointer),
                    ElementState::Released => Event::Released(button, self.pointer),
                });
            }
            WindowEvent::MouseWheel { delta, .. } => {
                let notches = match delta {
                    MouseScrollDelta::LineDelta(_, lines) => f64::from(lines),
                    MouseScrollDelta::PixelDelta(by) => by.y / NOTCH,
                };
                self.report(Event::Wheel(notches));
            }
            WindowEvent::KeyboardInput { event, is_synthetic: false, .. }
                if event.state == ElementState::Pressed =>
            {
                self.key(event_loop, &event.logical_key);
            }
            _ => {}
        }
    }
}

fn key(named: NamedKey) -> Option<Key> {
    Some(match named {
        NamedKey::Enter => Key::Return,
        NamedKey::Escape => Key::Escape,
        NamedKey::Backspace => Key::Backspace,
        NamedKey::Delete => Key::Delete,
        NamedKey::Tab => Key::Tab,
        NamedKey::ArrowLeft => Key::Left,
        NamedKey::ArrowRight => Key::Right,
        NamedKey::ArrowUp => Key::Up,
        NamedKey::ArrowDown => Key::Down,
        NamedKey::Home => Key::Home,
        NamedKey::End => Key::End,
        NamedKey::PageUp => Key::PageUp,
        NamedKey::PageDown => Key::PageDown,
        NamedKey::F1 => Key::Function(1),
        NamedKey::F2 => Key::Function(2),
        NamedKey::F3 => Key::Function(3),
        NamedKey::F4 => Key::Function(4),
        NamedKey::F5 => Key::Function(5),
        NamedKey::F6 => Key::Function(6),
        NamedKey::F7 => Key::Function(7),
        NamedKey::F8 => Key::Function(8),
        NamedKey::F9 => Key::Function(9),
        NamedKey::F10 => Key::Function(10),
        NamedKey::F11 => Key::Function(11),
        NamedKey::F12 => Key::Function(12),
        _ => return None,
    })
}
