//! A module in an interpreter, asked as a page asks it.

use wasmi::{Config, Engine, Linker, Memory, Store, TrapCode, TypedFunc};

/// What one request may cost, in the interpreter's fuel, about one an instruction: a few seconds, for what takes a
/// compiler's code tens of milliseconds. Counted rather than timed, so that no figure is dear on a busy machine only.
const FUEL: u64 = 1_000_000_000;

/// A validated module.
pub struct Module {
    engine: Engine,
    module: wasmi::Module,
}

/// A started one. After a trap it is of no use.
pub struct Running {
    store: Store<()>,
    memory: Memory,
    request: TypedFunc<u32, u32>,
    answer: TypedFunc<(), u32>,
    text: TypedFunc<(), u32>,
    length: TypedFunc<(), u32>,
}

/// Why there is no figure.
#[derive(Debug, PartialEq)]
pub enum Refusal {
    /// The module says so, in these words.
    Fault(String),
    /// The module broke down.
    Broken(String),
    /// It would take more than the interpreter is given.
    TooDear,
}

impl From<wasmi::Error> for Refusal {
    fn from(error: wasmi::Error) -> Self {
        match error.as_trap_code() {
            Some(TrapCode::OutOfFuel) => Self::TooDear,
            _ => Self::Broken(error.to_string()),
        }
    }
}

impl Module {
    /// Reads and validates it.
    pub fn new(wasm: &[u8]) -> Result<Self, Refusal> {
        let mut config = Config::default();
        config.consume_fuel(true);
        let engine = Engine::new(&config);
        let module = wasmi::Module::new(&engine, wasm)?;
        Ok(Self { engine, module })
    }

    /// Starts it; there is nothing that it could import.
    pub fn start(&self) -> Result<Running, Refusal> {
        let mut store = Store::new(&self.engine, ());
        store.set_fuel(FUEL)?;
        let instance = Linker::new(&self.engine).instantiate_and_start(&mut store, &self.module)?;
        Ok(Running {
            memory: instance.get_memory(&store, "memory").ok_or(Refusal::Broken("it exports no memory".into()))?,
            request: instance.get_typed_func(&store, "lesson_request")?,
            answer: instance.get_typed_func(&store, "lesson_answer")?,
            text: instance.get_typed_func(&store, "lesson_text")?,
            length: instance.get_typed_func(&store, "lesson_length")?,
            store,
        })
    }
}

impl Running {
    /// The SVG that the bytes of a request ask for.
    pub fn ask(&mut self, request: impl AsRef<[u8]>) -> Result<String, Refusal> {
        let broken = |error: &dyn std::fmt::Display| Refusal::Broken(error.to_string());
        let (store, request) = (&mut self.store, request.as_ref());
        store.set_fuel(FUEL)?;
        let room = self.request.call(&mut *store, request.len() as u32)?;
        self.memory.write(&mut *store, room as usize, request).map_err(|error| broken(&error))?;
        let failed = self.answer.call(&mut *store, ())?;
        let at = self.text.call(&mut *store, ())?;
        let mut answer = vec![0; self.length.call(&mut *store, ())? as usize];
        self.memory.read(&*store, at as usize, &mut answer).map_err(|error| broken(&error))?;
        let answer = String::from_utf8(answer).map_err(|error| broken(&error))?;
        if failed == 0 { Ok(answer) } else { Err(Refusal::Fault(answer)) }
    }
}
