//! A module in an interpreter, asked as a page asks it.

use wasmi::{Engine, Instance, Linker, Memory, Store, TypedFunc};

pub struct Module {
    store: Store<()>,
    memory: Memory,
    request: TypedFunc<u32, u32>,
    answer: TypedFunc<(), u32>,
    text: TypedFunc<(), u32>,
    length: TypedFunc<(), u32>,
}

fn words(fault: impl std::fmt::Display) -> String {
    fault.to_string()
}

impl Module {
    /// Validated and started; it may import nothing.
    pub fn load(wasm: &[u8]) -> Result<Self, String> {
        let engine = Engine::default();
        let module = wasmi::Module::new(&engine, wasm).map_err(words)?;
        let mut store = Store::new(&engine, ());
        let instance = Linker::new(&engine).instantiate_and_start(&mut store, &module).map_err(words)?;
        fn nullary(instance: &Instance, store: &Store<()>, name: &str) -> Result<TypedFunc<(), u32>, String> {
            instance.get_typed_func(store, name).map_err(words)
        }
        Ok(Self {
            memory: instance.get_memory(&store, "memory").ok_or("the module exports no memory")?,
            request: instance.get_typed_func(&store, "lesson_request").map_err(words)?,
            answer: nullary(&instance, &store, "lesson_answer")?,
            text: nullary(&instance, &store, "lesson_text")?,
            length: nullary(&instance, &store, "lesson_length")?,
            store,
        })
    }

    /// The SVG, or the text of the fault or of the trap.
    pub fn ask(&mut self, request: &str) -> Result<String, String> {
        self.ask_bytes(request.as_bytes())
    }

    /// The same for bytes that need not be text.
    pub fn ask_bytes(&mut self, request: &[u8]) -> Result<String, String> {
        let store = &mut self.store;
        let length = u32::try_from(request.len()).map_err(words)?;
        let room = self.request.call(&mut *store, length).map_err(words)?;
        self.memory.write(&mut *store, room as usize, request).map_err(words)?;
        let failed = self.answer.call(&mut *store, ()).map_err(words)?;
        let at = self.text.call(&mut *store, ()).map_err(words)?;
        let length = self.length.call(&mut *store, ()).map_err(words)?;
        let mut answer = Vec::new();
        let memory = self.memory.data(&*store);
        answer.extend_from_slice(
            memory.get(at as usize..).and_then(|rest| rest.get(..length as usize)).ok_or("outside")?,
        );
        let answer = String::from_utf8(answer).map_err(words)?;
        if failed == 0 { Ok(answer) } else { Err(answer) }
    }
}
