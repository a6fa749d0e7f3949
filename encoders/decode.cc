#include "encoders/decode.h"
