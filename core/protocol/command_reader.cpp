#include "core/protocol/command_reader.h"
