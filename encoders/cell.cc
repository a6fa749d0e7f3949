#include "encoders/cell.h"
