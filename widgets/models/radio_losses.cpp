#include "widgets/models/radio_losses.h"

#include <QObject>

#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

QString keyOf(const std::pair<QString, QString>& pair) {
    return QStringLiteral("radio/%1/%2").arg(pair.first, pair.second);
}

QString whyLost(const RadioLink& link) {
    return link.strength_dbm
               ? QObject::tr("%1 and %2 have lost their radio link: %3 dBm, and %4 dBm are needed. Bring them closer "
                             "together, or out from behind what stands between.")
                     .arg(link.a, link.b, figure(*link.strength_dbm, 1), figure(radio_cutoff_dbm, 0))
               : QObject::tr("%1 and %2 do not hear each other any more: one of them has left the world, or its "
                             "battery is empty. Look at their states in the list of robots.")
                     .arg(link.a, link.b);
}

} // namespace

std::vector<RadioLosses::News> RadioLosses::take(const std::vector<RadioLink>& links, const QStringList& robots) {
    std::vector<News> news;
    for (const RadioLink& link : links) {
        const bool linked = link.strength_dbm && *link.strength_dbm >= radio_cutoff_dbm;
        const auto known = linked_.find({link.a, link.b});
        if (known == linked_.end()) {
            if (linked)
                linked_[{link.a, link.b}] = true;
        } else if (std::exchange(known->second, linked) != linked) {
            news.push_back({keyOf(known->first), linked ? QString() : whyLost(link)});
        }
    }
    std::erase_if(linked_, [&](const auto& one) {
        const auto& [pair, linked] = one;
        const bool gone = !robots.contains(pair.first) || !robots.contains(pair.second);
        if (gone && !linked)
            news.push_back({keyOf(pair), {}});
        return gone;
    });
    return news;
}

} // namespace usar::widgets
