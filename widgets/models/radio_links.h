// Radio links between robots as list rows: current strength, its history over the last minutes, and links that were
// lost.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <QColor>
#include <QString>
#include <QStringList>

#include "widgets/models/row_model.h"

namespace usar::widgets {

/// Signal strength between two robots, the same in both directions; nullopt if the server does not know it.
struct RadioLink {
    QString a;
    QString b;
    std::optional<double> strength_dbm;
    bool operator==(const RadioLink&) const = default;
};

/// Threshold below which there is no link: the default of the wireless server, because no server reports its own.
inline constexpr double radio_cutoff_dbm = -93.0;
/// Attenuation of one wall (same source); quality is the number of walls that a link could still pass.
inline constexpr double radio_wall_db = 6.325;

/// Unknown: the server does not know. Lost: below the threshold.
enum class RadioQuality { Unknown, Lost, Weak, Fair, Good };
/// Weak: one more wall ends the link. Fair: two more do.
RadioQuality radioQuality(const std::optional<double>& strength_dbm);
/// Number of bars, 0 to 4: the further walls that would end the link; 0 without a link.
int radioBars(const std::optional<double>& strength_dbm);
/// "good", "fair", "weak", "no link", "not heard".
QString radioWord(RadioQuality quality);
/// Color in the current theme.
QColor radioColor(RadioQuality quality);

/// A link with its history.
struct RadioRow {
    RadioLink link;
    std::vector<double> history_dbm; ///< oldest first, one value per report; NaN: unknown
    bool operator==(const RadioRow&) const = default;
};

/// One row per pair, sorted by name. DisplayRole is a complete sentence; views paint from `row`. GUI thread.
class RadioLinkModel : public RowModel<RadioRow> {
    Q_OBJECT
public:
    static constexpr std::size_t most_samples = 120; ///< two minutes at one report per second

    using RowModel::RowModel;

    /// Replaces all links and appends to their histories; pairs that are missing are removed.
    void take(std::vector<RadioLink> links);
    QVariant data(const QModelIndex& index, int role) const override;
};

/// Compares each report of signal strengths with the one before. A pair that was never linked has lost nothing. A plain
/// value.
class RadioLosses {
public:
    /// What to say of all lost links together, so that many robots are one notice.
    struct News {
        QString text;       ///< which links are lost, and what to do; empty: none is any more
        bool first = false; ///< until now no link was lost
    };

    /// Takes the newest strengths of all pairs; `robots` are the names of those that still exist. Returns nullopt if
    /// the same links are lost as before.
    std::optional<News> take(const std::vector<RadioLink>& links, const QStringList& robots);

private:
    using Pair = std::pair<QString, QString>;

    std::map<Pair, RadioLink> known_; ///< newest report; only pairs that have been linked
    std::set<Pair> lost_;             ///< those of them without a link now
};

} // namespace usar::widgets
