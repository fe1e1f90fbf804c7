// One line of traffic taken apart: values with units, what is wrong under a caret, and why it was sent.
#pragma once

#include <QTextBrowser>

#include "widgets/models/message_model.h"

namespace usar::widgets {

/// Shows a copy of the row, so it stays when the row falls out of the ring. Links jump to the line that caused a
/// command, and to the commands that a line caused. GUI thread.
class MessageDetail : public QTextBrowser {
    Q_OBJECT
public:
    explicit MessageDetail(QWidget* parent = nullptr);

    void show(const MessageModel& model, std::uint64_t serial);
    void clearRow();
    QSize sizeHint() const override { return {320, 160}; }
    QSize minimumSizeHint() const override { return {200, 60}; }

signals:
    /// A serial number of the model's.
    void jumpRequested(std::uint64_t serial);

protected:
    void changeEvent(QEvent* event) override;

private:
    QString headOf(const MessageModel& model, const MessageRow& row) const;
    QString causeOf(const MessageModel& model, const MessageRow& row, std::uint64_t serial) const;
    QString sourceOf(const MessageModel& model, const MessageRow& row) const;
    QString bodyOf(const MessageRow& row) const;
    void render();

    QString head_; ///< HTML; without colors, so that it outlives a change of the theme
    std::optional<MessageRow> row_;
};

} // namespace usar::widgets
