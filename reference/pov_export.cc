#include "reference/pov_export.h"
