#include "widgets/models/radio_links.h"

#include <algorithm>
#include <limits>
#include <ranges>

#include <QObject>

#include "widgets/models/figures.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

constexpr int most_bars = 4;

std::pair<QString, QString> pairOf(const RadioLink& link) {
    return {link.a, link.b};
}

bool isLinked(const RadioLink& link) {
    return link.strength_dbm && *link.strength_dbm >= radio_cutoff_dbm;
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

QString whyManyLost(const std::set<std::pair<QString, QString>>& lost) {
    constexpr std::size_t most_names = 3;
    QStringList names;
    for (const auto& [a, b] : lost | std::views::take(most_names))
        names << QObject::tr("%1 and %2").arg(a, b);
    if (lost.size() > most_names)
        names << QObject::tr("%1 more").arg(lost.size() - most_names);
    return QObject::tr("%1 pairs of robots have lost their radio link: %2. The Radio dock shows all links.")
        .arg(lost.size())
        .arg(names.join(QStringLiteral(", ")));
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

std::optional<RadioLosses::News> RadioLosses::take(const std::vector<RadioLink>& links, const QStringList& robots) {
    for (const RadioLink& link : links)
        if (isLinked(link) || known_.contains(pairOf(link)))
            known_[pairOf(link)] = link;
    std::erase_if(known_, [&](const auto& one) {
        return !robots.contains(one.first.first) || !robots.contains(one.first.second);
    });
    std::set<Pair> lost;
    for (const auto& [pair, link] : known_)
        if (!isLinked(link))
            lost.insert(pair);
    if (lost == lost_)
        return std::nullopt;
    const bool first = std::exchange(lost_, lost).empty();
    if (lost.size() <= 1)
        return News{lost.empty() ? QString() : whyLost(known_.at(*lost.begin())), first};
    return News{whyManyLost(lost), first};
}

} // namespace usar::widgets
