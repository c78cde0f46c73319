mod audit;
mod coated;
mod diffuse;
mod digits;
mod draws;
mod forms;
mod fresnel;
mod hostile;
mod rough;

use super::audit::direction;
