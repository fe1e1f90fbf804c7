#include "core/protocol/command_writer.h"
