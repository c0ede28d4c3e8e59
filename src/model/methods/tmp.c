#include "kernel.h"
const struct kernel kernel_gsl = {0};
const struct kernel kernel_paper = {0};
