#include "core/agent/published.h"

#include "core/base/sealed_definitions.h"

template class usar::Sealed<usar::agent::PublishedVariant>;
