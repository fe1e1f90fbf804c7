// Radio links between robots: strength now and over the last minutes, as rows.
#pragma once

#include <optional>
#include <vector>

#include <QAbstractListModel>
#include <QColor>
#include <QString>

namespace usar::widgets {

/// Between two robots, the same both ways; nothing where the server cannot say.
struct RadioLink {
    QString a;
    QString b;
    std::optional<double> strength_dbm;
    bool operator==(const RadioLink&) const = default;
};

/// Below it there is no link: the wireless server's default, for no server tells its own.
inline constexpr double radio_cutoff_dbm = -93.0;
/// What a wall takes (the same source); quality is counted in walls that a link would stand.
inline constexpr double radio_wall_db = 6.325;

enum class RadioQuality { Unknown, Lost, Weak, Fair, Good };
/// Weak: one wall more ends it. Fair: two do.
RadioQuality radioQuality(const std::optional<double>& strength_dbm);
/// 0 to 4: so many walls more it would stand, and 0 without a link.
int radioBars(const std::optional<double>& strength_dbm);
QString radioWord(RadioQuality quality);
/// Of the theme applied last.
QColor radioColor(RadioQuality quality);

struct RadioRow {
    RadioLink link;
    std::vector<double> history_dbm; ///< oldest first, one a report; NaN where nothing was known
};

/// One row a pair, in the order of the names. DisplayRole is a whole sentence; views paint from `row`. GUI thread.
class RadioLinkModel : public QAbstractListModel {
    Q_OBJECT
public:
    static constexpr std::size_t most_samples = 120; ///< two minutes of a report a second

    using QAbstractListModel::QAbstractListModel;

    /// All that are known now; pairs that are not among them go.
    void take(std::vector<RadioLink> links);
    const RadioRow& row(int index) const { return rows_[static_cast<std::size_t>(index)]; }
    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    std::vector<RadioRow> rows_;
};

} // namespace usar::widgets
