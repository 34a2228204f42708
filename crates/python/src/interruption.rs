//! Ctrl-C during long work of the kernel. Both ways are for a thread that has released the GIL.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::RecvTimeoutError;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use strainwave_kernel::IsCancelled;

/// How often running work looks for Ctrl-C.
const PATIENCE: Duration = Duration::from_millis(50);

/// Runs `work` on this thread and looks for Ctrl-C when it asks whether it is cancelled.
pub fn stoppable_here<T>(work: impl FnOnce(IsCancelled) -> Option<T>) -> PyResult<T> {
    let watch = Mutex::new((Instant::now(), None));
    let answer = work(&|| {
        let (looked, interrupt) = &mut *watch.lock().unwrap_or_else(PoisonError::into_inner);
        if interrupt.is_none() && looked.elapsed() >= PATIENCE {
            *interrupt = Python::attach(|py| py.check_signals()).err();
            *looked = Instant::now();
        }
        interrupt.is_some()
    });
    match watch.into_inner().unwrap_or_else(PoisonError::into_inner).1 {
        Some(interrupt) => Err(interrupt),
        None => answer.ok_or_else(unanswered),
    }
}

/// Runs `work`, which spreads over many threads, on one of its own and looks for Ctrl-C meanwhile.
pub fn stoppable<T: Send>(work: impl FnOnce(IsCancelled) -> Option<T> + Send) -> PyResult<T> {
    let cancelled = AtomicBool::new(false);
    let (sender, receiver) = std::sync::mpsc::channel();
    std::thread::scope(|scope| {
        let cancelled = &cancelled;
        // Sending fails only after an interrupt, when nobody waits for the answer.
        scope.spawn(move || drop(sender.send(work(&|| cancelled.load(Ordering::Relaxed)))));
        loop {
            match receiver.recv_timeout(PATIENCE) {
                Ok(answer) => return answer.ok_or_else(unanswered),
                Err(RecvTimeoutError::Timeout) => {
                    if let Err(interrupt) = Python::attach(|py| py.check_signals()) {
                        cancelled.store(true, Ordering::Relaxed);
                        return Err(interrupt);
                    }
                }
                Err(RecvTimeoutError::Disconnected) => return Err(unanswered()),
            }
        }
    })
}

/// Nobody has interrupted the work; so it has panicked, or cancelled itself.
fn unanswered() -> PyErr {
    PyRuntimeError::new_err("the work ended without an answer")
}
