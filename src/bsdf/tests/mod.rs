mod audit;
mod coated;
mod diffuse;
mod digits;
mod draws;
mod forms;
mod fresnel;
mod hostile;
mod rough;
mod rough_coated;

use super::audit::direction;
