// The newest lines of traffic in bounded memory, filtered, as a table model for long logs.
#pragma once

#include <deque>
#include <vector>

#include <QAbstractTableModel>

#include "widgets/models/message_row.h"

namespace usar::widgets {

/// Both must fit; a default filter lets everything through.
struct MessageFilter {
    QString words; ///< in type or text, whatever the case; empty for all
    std::optional<Direction> direction;
    bool operator==(const MessageFilter&) const = default;
};

/// A ring: the oldest rows fall out at `capacity` rows or `capacity_bytes` of text. It filters by itself, because a
/// proxy would be told of every row twice. Feed it once a frame. GUI thread.
class MessageModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Number, Time, Way, Type, Text, column_count };
    static constexpr std::size_t default_capacity = 100'000;
    static constexpr std::size_t default_capacity_bytes = 64U << 20U;

    explicit MessageModel(QObject* parent = nullptr, std::size_t capacity = default_capacity,
                          std::size_t capacity_bytes = default_capacity_bytes);

    /// In order; one insertion for all. Says how many shown rows fell out at the top.
    int append(std::vector<MessageRow> batch);
    /// Takes all rows away; the filter stays.
    void clear();
    /// Goes through all rows: some 50 ms for a hundred thousand.
    void setFilter(const MessageFilter& filter);
    const MessageFilter& filter() const { return filter_; }

    std::size_t capacity() const { return capacity_; }
    /// Shown or not.
    int total() const { return static_cast<int>(rows_.size()); }
    /// Of the `shown`-th row of the table; valid until the next change.
    const MessageRow& row(int shown) const;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    /// Cuts what cannot stay off the front of `batch`, and says how many rows must go to make room for the rest.
    void trim(std::vector<MessageRow>& batch, std::size_t& drop) const;
    /// How many of those were shown.
    int dropOldest(std::size_t count);
    QVariant shownText(const MessageRow& row, int column) const;
    QVariant ink(const MessageRow& row, int column) const;

    std::size_t capacity_;
    std::size_t capacity_bytes_;
    std::deque<MessageRow> rows_;
    std::uint64_t dropped_ = 0;       ///< rows that fell out so far: the serial number of rows_.front()
    std::deque<std::uint64_t> shown_; ///< serial numbers of the rows that pass the filter
    std::size_t bytes_ = 0;           ///< of rows_
    MessageFilter filter_;
};

} // namespace usar::widgets
