#include "core/protocol/line_splitter.h"
