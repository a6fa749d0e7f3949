#include "encoders/encoder.h"
