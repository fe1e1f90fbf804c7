// Details of one line of traffic: values with units, errors with a caret below the column, and why it was sent.
#pragma once

#include <QTextBrowser>

#include "widgets/models/messages/message_model.h"

namespace usar::widgets {

/// Keeps a copy of the row, so the details stay when the row leaves the ring. Links jump to the line that caused a
/// command, and to the commands that a line caused. GUI thread.
class MessageDetail : public QTextBrowser {
    Q_OBJECT
public:
    explicit MessageDetail(QWidget* parent = nullptr);

    /// Shows the row with this serial number; a row that has left the ring changes nothing.
    void show(const MessageModel& model, std::uint64_t serial);
    /// Shows the sentence that says what will appear here.
    void clearRow();
    QSize sizeHint() const override { return {320, 160}; }
    QSize minimumSizeHint() const override { return {200, 60}; }

signals:
    /// `serial` is a serial number of the model.
    void jumpRequested(std::uint64_t serial);

private:
    /// Type, number, direction, robot and time; for omitted lines the number of them.
    QString headOf(const MessageModel& model, const MessageRow& row) const;
    /// Who sent a command and why, and links to the commands that the line caused; may be empty.
    QString causeOf(const MessageModel& model, const MessageRow& row, std::uint64_t serial) const;
    /// The sender of a command, with a link to the line that triggered it if that is still in the ring.
    QString sourceOf(const MessageModel& model, const MessageRow& row) const;
    /// The line, its errors with carets, and tables of its values; long ones are cut.
    QString bodyOf(const MessageRow& row) const;
    void render() { setHtml(head_ + (row_ ? bodyOf(*row_) : QString())); }

    QString head_; ///< HTML without colors, so that it survives a change of theme
    std::optional<MessageRow> row_;
};

} // namespace usar::widgets
