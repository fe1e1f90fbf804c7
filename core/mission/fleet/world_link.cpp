#include "core/mission/fleet/world_link.h"

namespace usar::mission {

WorldLink::WorldLink(QObject* parent) : QObject(parent) {
    link::connectAcross(session_.get(), &WorldSession::changed, this, [this](const auto& view) {
        view_ = view;
        emit changed();
    });
    link::connectAcross(session_.get(), &WorldSession::noticed, this, &WorldLink::noticed);
}

} // namespace usar::mission
