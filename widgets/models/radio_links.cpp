#include "widgets/models/radio_links.h"

#include <algorithm>
#include <limits>

#include <QObject>

#include "widgets/models/figures.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

constexpr int most_bars = 4;

std::pair<QString, QString> pairOf(const RadioLink& link) {
    return {link.a, link.b};
}

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

RadioQuality radioQuality(const std::optional<double>& strength_dbm) {
    using enum RadioQuality;
    if (!strength_dbm)
        return Unknown;
    constexpr RadioQuality by_bars[] = {Lost, Weak, Fair, Good, Good};
    return by_bars[radioBars(strength_dbm)];
}

int radioBars(const std::optional<double>& strength_dbm) {
    if (!strength_dbm || !(*strength_dbm >= radio_cutoff_dbm))
        return 0;
    return 1 + static_cast<int>(std::min(most_bars - 1.0, (*strength_dbm - radio_cutoff_dbm) / radio_wall_db));
}

QString radioWord(RadioQuality quality) {
    const QString words[] = {QObject::tr("not heard"), QObject::tr("no link"), QObject::tr("weak"), QObject::tr("fair"),
                             QObject::tr("good")};
    return words[static_cast<std::size_t>(quality)];
}

QColor radioColor(RadioQuality quality) {
    const Tokens& t = tokens();
    const QColor colors[] = {t.stale, t.danger, t.caution, t.caution, t.ok};
    return colors[static_cast<std::size_t>(quality)];
}

void RadioLinkModel::take(std::vector<RadioLink> links) {
    std::ranges::sort(links, {}, pairOf);
    const auto pair_of_row = [](const RadioRow& row) { return pairOf(row.link); };
    std::vector<RadioRow> rows;
    for (const RadioLink& link : links) {
        const auto known = std::ranges::find(rows_, pairOf(link), pair_of_row);
        RadioRow& row = rows.emplace_back(known == rows_.end() ? RadioRow{} : *known);
        row.link = link;
        if (row.history_dbm.size() == most_samples)
            row.history_dbm.erase(row.history_dbm.begin());
        row.history_dbm.push_back(link.strength_dbm.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    replaceAll(std::move(rows), pair_of_row);
}

QVariant RadioLinkModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || (role != Qt::DisplayRole && role != Qt::ToolTipRole && role != Qt::AccessibleTextRole))
        return {};
    const RadioLink& link = row(index.row()).link;
    const QString word = radioWord(radioQuality(link.strength_dbm));
    if (!link.strength_dbm)
        return tr("%1 and %2: %3").arg(link.a, link.b, word);
    return tr("%1 and %2: %3 dBm, %4").arg(link.a, link.b, figure(*link.strength_dbm, 1), word);
}

std::vector<RadioLosses::News> RadioLosses::take(const std::vector<RadioLink>& links, const QStringList& robots) {
    std::vector<News> news;
    for (const RadioLink& link : links) {
        const bool linked = link.strength_dbm && *link.strength_dbm >= radio_cutoff_dbm;
        const auto known = linked_.find(pairOf(link));
        if (known == linked_.end()) {
            if (linked)
                linked_[pairOf(link)] = true;
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
