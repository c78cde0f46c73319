//! Work on as many threads as there are.

/// Of each the result, in order.
pub(crate) fn mapped<A: Sync, T: Send>(all: &[A], of: impl Fn(&A) -> T + Sync + Send) -> Vec<T> {
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        all.par_iter().map(of).collect()
    }
    #[cfg(not(feature = "parallel"))]
    all.iter().map(of).collect()
}
