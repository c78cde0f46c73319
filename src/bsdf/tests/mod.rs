mod audit;
mod diffuse;
mod digits;
mod hostile;
mod rough;

use super::audit::direction;
