// What the robot really sends, as a tree: one branch a source, one leaf a value, each with its age and rate.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include <QAbstractItemModel>

#include "core/protocol/fields.h"

namespace usar::widgets {

/// Made from protocol::fieldsOf, so unknown sensors appear like known ones. take() only notes; flush() tells the views,
/// once a frame. A value is stale when its age exceeds three of its periods and one second; answers (GEO, CONF, NFO,
/// RES) are sent once and never stale. Ages count on the clock given as `now`. GUI thread.
class SensorModel : public QAbstractItemModel {
    Q_OBJECT
public:
    /// Value is right-aligned text; Unit stands beside it, so that figures line up.
    enum Column { Name, Value, Unit, Age, Rate, ColumnCount };
    /// SortRole puts what is sent again and again before answers, each in order of first appearance.
    enum Role { PathRole = Qt::UserRole, UnitRole, StaleRole, NumericRole, SortRole };

    explicit SensorModel(QObject* parent = nullptr);

    /// `count` lines of this stream came since the last one was taken, this one included.
    void take(const protocol::InfoLine& line, Seconds now, int count = 1);
    /// Tells views what changed since the last flush; ages are those of `now`. Without a link every value is stale.
    void flush(Seconds now, bool linked = true);
    /// Forgets every stream: another robot is shown.
    void clear();
    /// The stream words that were heard ("INS", "RangeScanner"), in order of first appearance.
    QStringList types() const;

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& child) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QStringList mimeTypes() const override;
    /// The paths of the numeric values among `indexes`.
    QMimeData* mimeData(const QModelIndexList& indexes) const override;

private:
    /// When something last came and how often it comes, on the caller's clock.
    struct Timing {
        Seconds last{0.0};
        std::optional<Seconds> period;
        bool repeats = true; ///< false: an answer, sent once
        void arrived(Seconds now, int count);
        bool stale(Seconds now, bool linked) const;
    };
    /// One value with the newest field it came in.
    struct Leaf {
        protocol::Field field;
        Timing timing;
        int decimals = 0; ///< grows, never shrinks: the width must not jump
    };
    /// One stream word of the wire with its values in the server's order.
    struct Source {
        QString name;
        Timing timing;
        std::vector<Leaf> leaves;
        bool single = true; ///< all values are of one item, whose name is then said once, not on every line
        /// "INS", "RangeScanner  Scanner1", "Sonar": what kind, and which one where there is but one.
        QString title() const;
    };

    /// Inserts the branch when it is new. The reference holds until the next call.
    Source& sourceNamed(const std::string& name, bool repeats);
    void takeField(Source& source, const protocol::Field& field, Seconds now, int count, bool repeats);
    const Leaf* leafAt(const QModelIndex& index) const;
    const Timing& timingAt(const QModelIndex& index) const;
    QVariant text(const QModelIndex& index) const;
    QString valueText(const Leaf& leaf) const;
    /// Color and font: grey and struck when stale, branches bold.
    QVariant look(const QModelIndex& index, int role) const;

    std::vector<Source> sources_;
    std::unordered_map<std::string, std::size_t> source_rows_;
    std::unordered_map<std::string, std::size_t> leaf_rows_; ///< by path, within the source
    Seconds now_{0.0};
    bool linked_ = true;
};

} // namespace usar::widgets
