#include "core/protocol/info_message.h"

#include "core/base/sealed_definitions.h"

template class usar::Sealed<usar::protocol::InfoVariant>;
