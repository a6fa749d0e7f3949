#include "harness/metrics/metric.h"
