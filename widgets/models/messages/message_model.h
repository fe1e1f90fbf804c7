// Table model of the newest lines of traffic, filtered and in bounded memory.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QAbstractTableModel>
#include <QTimer>

#include "widgets/models/messages/message_filter.h"
#include "widgets/models/messages/message_row.h"

namespace usar::widgets {

/// A ring: beyond `capacity` rows or `capacity_bytes` of memory the oldest rows are removed. It filters by itself,
/// because a proxy model would be told about every row twice. A new filter is applied in slices, from the newest row
/// backward, so that it never blocks the window; older rows that pass are inserted at the top. Call append once per
/// frame. GUI thread.
class MessageModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Number, Time, Robot, Way, Type, Text, column_count };
    static constexpr std::size_t default_capacity = 100'000;
    static constexpr std::size_t default_capacity_bytes = 160U << 20U;

    explicit MessageModel(QObject* parent = nullptr, std::size_t capacity = default_capacity,
                          std::size_t capacity_bytes = default_capacity_bytes);

    /// Appends rows in order with a single insertion. Returns how many shown rows were removed at the top.
    int append(std::vector<MessageRow> batch);
    /// Removes all rows; the filter stays.
    void clear();
    /// Filters the newest rows at once and older ones in slices of a few milliseconds; `filtered` is emitted when all
    /// are done.
    void setFilter(const MessageFilter& filter);
    /// Does the rest of a filter's work at once.
    void finishFilter();
    const MessageFilter& filter() const { return filter_; }
    /// True while older rows still wait for the filter.
    bool filtering() const { return unseen_ > dropped_; }
    /// Sets what the Robot column shows for a connection.
    void nameConnection(ConnectionId connection, const QString& name);
    /// Empty if the connection has no name.
    QString connectionName(ConnectionId connection) const;

    std::size_t capacity() const { return capacity_; }
    /// Number of stored rows, shown or not.
    int total() const { return static_cast<int>(rows_.size()); }
    /// Number of stored rows of that connection.
    int totalOf(ConnectionId connection) const;
    /// Types of the stored rows, with the number of rows of each.
    const std::map<std::string, int, std::less<>>& types() const { return types_; }
    /// The `shown`-th row of the table; the reference is valid until the next change.
    const MessageRow& row(int shown) const { return rows_[shown_[static_cast<std::size_t>(shown)] - dropped_]; }
    /// Serial number of that row of the table; it stays with the row as long as the row is stored.
    std::uint64_t serial(int shown) const { return shown_[static_cast<std::size_t>(shown)]; }
    /// Row of the table with this serial number; -1 if it is not shown.
    int shownRow(std::uint64_t serial) const;
    /// Stored row with this serial number; nullptr if it has been removed.
    const MessageRow* find(std::uint64_t serial) const;
    /// Serial number of the newest such line, shown or not; nullopt if none is stored.
    std::optional<std::uint64_t> serialOf(ConnectionId connection, Direction direction, std::uint64_t number) const;
    /// Serial numbers of the commands that this info line caused; at most five, all soon after it.
    std::vector<std::uint64_t> causedBy(std::uint64_t serial) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : column_count; }
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

signals:
    /// Every row has been tested against the filter.
    void filtered();

private:
    /// Removes from the front of `batch` the rows that would not fit, and sets `drop` to the number of stored rows that
    /// must go to make room for the rest.
    void trim(std::vector<MessageRow>& batch, std::size_t& drop) const;
    /// Removes the oldest rows; returns how many of them were shown.
    int dropOldest(std::size_t count);
    /// Adds `more` (1 or -1) to the counts of the row's type and connection.
    void tally(const MessageRow& row, int more);
    /// Tests rows before `unseen_` for at most `budget_ms`; returns the serial numbers of those that pass, oldest
    /// first.
    std::deque<std::uint64_t> sieveSlice(qint64 budget_ms);
    /// Continues the filter's work for at most `budget_ms`.
    void filterOn(qint64 budget_ms);
    QVariant shownText(const MessageRow& row, int column) const;

    std::size_t capacity_;
    std::size_t capacity_bytes_;
    std::deque<MessageRow> rows_;
    std::uint64_t dropped_ = 0;       ///< number of rows removed so far, which is the serial number of rows_.front()
    std::deque<std::uint64_t> shown_; ///< serial numbers of the rows that pass the filter
    std::uint64_t unseen_ = 0;        ///< rows before this serial number have not been tested yet
    std::size_t bytes_ = 0;           ///< memory used by rows_
    std::map<std::string, int, std::less<>> types_;
    std::map<ConnectionId, int> totals_; ///< number of rows by connection
    /// Names by connection.
    std::map<ConnectionId, QString> names_;
    MessageFilter filter_;
    std::unique_ptr<MessageSieve> sieve_;
    QTimer slice_{this};
};

} // namespace usar::widgets
