// Whether this is being recorded, how long already and how much: always in sight.
#pragma once

#include <cstdint>
#include <optional>

#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include "core/base/clock.h"

namespace usar::widgets {

/// Of a recording that is being written.
struct RecordState {
    Seconds elapsed{0.0};
    std::uint64_t bytes = 0;
    QString path;
};

/// The button is the command's; its dot is red while bytes are being written. GUI thread.
class RecordBadge : public QWidget {
    Q_OBJECT
public:
    explicit RecordBadge(QWidget* parent = nullptr);

    void setAction(QAction* action);
    /// Nothing: nothing is being written now.
    void setState(const std::optional<RecordState>& state);
    /// Where there is no room for them the tooltip has them.
    void setFiguresShown(bool shown) { figures_->setVisible(shown); }
    QString text() const { return figures_->text(); }

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();

    QToolButton* button_;
    QLabel* figures_;
    bool writing_ = false;
};

} // namespace usar::widgets
