// Tree model of the values that a robot sends: one branch per source, one leaf per value, each with age and rate; and
// the buffer that it is fed from.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <QAbstractItemModel>

#include "core/base/clock.h"
#include "core/protocol/fields.h"
#include "core/protocol/info_message.h"

namespace usar::widgets {

/// Made from protocol::fieldsOf, so unknown sensors appear like known ones. take() only stores; flush() informs the
/// views, once per frame. A value is stale when its age exceeds both protocol::silence::reading and three of its
/// periods; answers (GEO, CONF, NFO, RES) are sent once and never become stale. Ages are measured on the clock passed
/// as `now`. GUI thread.
class SensorModel : public QAbstractItemModel {
    Q_OBJECT
public:
    /// Value is right-aligned text; Unit has a column of its own, so that the numbers line up.
    enum Column { Name, Value, Unit, Age, Rate, ColumnCount };
    /// SortRole orders repeated messages before answers, each in the order of first appearance.
    enum Role { PathRole = Qt::UserRole, UnitRole, NumericRole, SortRole };

    using QAbstractItemModel::QAbstractItemModel;

    /// `count` is the number of lines of this stream since the last one passed here, this one included.
    void take(const protocol::InfoLine& line, Seconds now, int count = 1);
    /// Informs the views of changes since the last flush; ages are as of `now`. Without a link every repeated value is
    /// stale.
    void flush(Seconds now, bool linked = true);
    /// Removes everything, for another robot.
    void clear();
    /// The stream words that were heard ("INS", "RangeScanner"), in order of first appearance.
    QStringList types() const;
    /// A value that can be plotted, with its unit.
    struct Number {
        QString path;
        QString unit;
    };
    /// All of them, in the order of the rows.
    std::vector<Number> numbers() const;

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& child) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& = {}) const override { return ColumnCount; }
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QStringList mimeTypes() const override;
    /// The paths of the numeric values among `indexes`; nullptr if there are none.
    QMimeData* mimeData(const QModelIndexList& indexes) const override;

private:
    /// When a value last arrived and how often it does, on the caller's clock.
    struct Timing {
        Seconds last{0.0};
        /// Smoothed; nullopt before the second arrival.
        std::optional<Seconds> period;
        bool repeats = true; ///< false: an answer, sent once
        /// `count` messages arrived since the last call.
        void arrived(Seconds now, int count);
        /// True if a repeated value is too old, or there is no link.
        bool stale(Seconds now, bool linked) const;
    };
    /// A value with the newest field that carried it.
    struct Leaf {
        protocol::Field field;
        Timing timing;
        int decimals = 0; ///< only grows, so that the width does not jump
    };
    /// One stream of the protocol with its values in the server's order.
    struct Source {
        QString name;
        Timing timing;
        std::vector<Leaf> leaves;
        bool single = true; ///< all values are of one item, whose name is then shown once instead of on every line
        /// "INS", "RangeScanner  Scanner1", "Sonar": the kind, and the item if there is only one.
        QString title() const;
    };

    /// Returns the branch, added if it is new. The reference is valid until the next call.
    Source& sourceNamed(const std::string& name, bool repeats);
    void takeField(Source& source, const protocol::Field& field, Seconds now, int count, bool repeats);
    /// The leaf at that index; nullptr for a branch.
    const Leaf* leafAt(const QModelIndex& index) const;
    const Timing& timingAt(const QModelIndex& index) const;
    QVariant text(const QModelIndex& index) const;
    QString valueText(const Leaf& leaf) const;
    /// Color and font: gray and struck through when stale, bold for branches.
    QVariant look(const QModelIndex& index, int role) const;

    std::vector<Source> sources_;
    std::unordered_map<std::string, std::size_t> source_rows_;
    std::unordered_map<std::string, std::size_t> leaf_rows_; ///< row by path, within the source
    Seconds now_{0.0};
    bool linked_ = true;
};

/// Key that distinguishes the streams of one connection: "SEN Sonar F1", "STA", "GEO RangeScanner".
std::string streamOf(const protocol::InfoMessage& message);

/// The newest line of a stream, and how many lines of the stream came since the last fetch, this one included.
struct CountedLine {
    protocol::InfoLine line;
    /// Clock at arrival, as passed to take().
    Seconds now{0.0};
    int count = 0;
};

/// Bounds the work of a slow or hidden view: a thousand lines of one stream cost as much as one. A line that is the
/// only one of its stream is never lost. A value with one owner.
class NewestLines {
public:
    /// Stores a line; it replaces the previous line of the same stream.
    void take(const protocol::InfoLine& line, Seconds now);
    /// The lines that were not removed yet, in the order in which their streams first appeared.
    const std::vector<CountedLine>& lines() const { return lines_; }
    /// Clock at the arrival of the newest stored line with a message of this type; nullopt: none.
    template <class Message>
    std::optional<Seconds> heard() const {
        std::optional<Seconds> newest;
        for (const CountedLine& one : lines_)
            if (std::holds_alternative<Message>(one.line.message))
                newest = std::max(newest, std::optional(one.now));
        return newest;
    }
    /// Removes and returns all lines, in the order in which their streams first appeared since the last call.
    std::vector<CountedLine> takeAll();

private:
    std::map<std::string, std::size_t> places_;
    std::vector<CountedLine> lines_;
};

} // namespace usar::widgets
