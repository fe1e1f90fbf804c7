// The newest lines of traffic in bounded memory, filtered, as a table model for long logs.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QAbstractTableModel>
#include <QTimer>

#include "widgets/models/message_filter.h"
#include "widgets/models/message_row.h"

namespace usar::widgets {

/// A ring: the oldest rows fall out at `capacity` rows or `capacity_bytes` of text. It filters by itself, because a
/// proxy would be told of every row twice, and in slices from the newest row back, so that no filter holds the window:
/// what passes comes in above what is there. Feed it once a frame. GUI thread.
class MessageModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Number, Time, Robot, Way, Type, Text, column_count };
    static constexpr std::size_t default_capacity = 100'000;
    static constexpr std::size_t default_capacity_bytes = 160U << 20U;

    explicit MessageModel(QObject* parent = nullptr, std::size_t capacity = default_capacity,
                          std::size_t capacity_bytes = default_capacity_bytes);

    /// In order; one insertion for all. Says how many shown rows fell out at the top.
    int append(std::vector<MessageRow> batch);
    /// Takes all rows away; the filter stays.
    void clear();
    /// The newest rows at once, older ones in slices of a few milliseconds; `filtered` says when all are done.
    void setFilter(const MessageFilter& filter);
    /// The rest of a filter's work, at one go.
    void finishFilter();
    const MessageFilter& filter() const { return filter_; }
    bool filtering() const { return unseen_ > dropped_; }
    /// What the Robot column says of a connection.
    void nameConnection(int connection, const QString& name);
    QString connectionName(int connection) const;

    std::size_t capacity() const { return capacity_; }
    /// Shown or not.
    int total() const { return static_cast<int>(rows_.size()); }
    int totalOf(int connection) const;
    /// Of the rows there are, with how many of each.
    const std::map<std::string, int, std::less<>>& types() const { return types_; }
    /// Of the `shown`-th row of the table; valid until the next change.
    const MessageRow& row(int shown) const;
    /// That row of the table goes on having this serial number, as long as it is kept.
    std::uint64_t serial(int shown) const { return shown_[static_cast<std::size_t>(shown)]; }
    /// -1 where it is not shown.
    int shownRow(std::uint64_t serial) const;
    /// nullptr where it has fallen out.
    const MessageRow* find(std::uint64_t serial) const;
    /// Of the newest such line, shown or not.
    std::optional<std::uint64_t> serialOf(int connection, Direction direction, std::uint64_t number) const;
    /// Serial numbers of the commands that this info line caused, a few at most.
    std::vector<std::uint64_t> causedBy(std::uint64_t serial) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

signals:
    /// Every row has been held against the filter.
    void filtered();

private:
    /// Cuts what cannot stay off the front of `batch`, and says how many rows must go to make room for the rest.
    void trim(std::vector<MessageRow>& batch, std::size_t& drop) const;
    /// How many of those were shown.
    int dropOldest(std::size_t count);
    void tally(const MessageRow& row, int more);
    /// Rows before `unseen_` that pass, oldest first, found within `budget_ms`.
    std::deque<std::uint64_t> sieveSlice(qint64 budget_ms);
    void filterOn(qint64 budget_ms);
    QVariant shownText(const MessageRow& row, int column) const;
    QVariant ink(const MessageRow& row, int column) const;

    std::size_t capacity_;
    std::size_t capacity_bytes_;
    std::deque<MessageRow> rows_;
    std::uint64_t dropped_ = 0;       ///< rows that fell out so far: the serial number of rows_.front()
    std::deque<std::uint64_t> shown_; ///< serial numbers of the rows that pass the filter
    std::uint64_t unseen_ = 0;        ///< rows before this serial number wait for the filter
    std::size_t bytes_ = 0;           ///< of rows_
    std::map<std::string, int, std::less<>> types_;
    std::map<int, int> totals_; ///< rows by connection
    std::map<int, QString> names_;
    MessageFilter filter_;
    std::unique_ptr<MessageSieve> sieve_;
    QTimer slice_{this};
};

} // namespace usar::widgets
