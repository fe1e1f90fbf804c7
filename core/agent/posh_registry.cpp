#include "core/agent/posh_registry.h"

namespace usar::agent {

PoshRegistry::Entry PoshRegistry::add(PoshPrimitive primitive) {
    const std::string name = primitive.description.name;
    return Entry(primitives_.insert_or_assign(name, std::move(primitive)).first->second.description);
}

const PoshPrimitive* PoshRegistry::find(std::string_view name) const {
    const auto found = primitives_.find(name);
    return found == primitives_.end() ? nullptr : &found->second;
}

std::vector<PrimitiveDescription> PoshRegistry::descriptions() const {
    std::vector<PrimitiveDescription> all;
    for (const auto& [name, primitive] : primitives_)
        all.push_back(primitive.description);
    return all;
}

} // namespace usar::agent
