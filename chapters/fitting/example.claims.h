/*
# example
*/
#include "chapters/frame/claims_off.h"
#include "chapters/frame/claims_on.h"
