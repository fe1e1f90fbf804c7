// Badge that always shows whether a recording is being written, for how long, and how large it is.
#pragma once

#include <cstdint>
#include <optional>

#include <QWidget>

#include "core/base/clock.h"
#include "widgets/style/form_parts.h"

namespace usar::widgets {

/// State of the recording that is being written.
struct RecordState {
    Seconds elapsed{0.0};    ///< since the beginning of the recording
    std::uint64_t bytes = 0; ///< size of the file so far
    QString path;
};

/// The button belongs to a command; its dot is red while a recording is being written. GUI thread.
class RecordBadge : public QWidget {
    Q_OBJECT
public:
    explicit RecordBadge(QWidget* parent = nullptr);

    /// The action of the button; it must outlive the badge.
    void setAction(QAction* action);
    /// `nullopt`: no recording is being written.
    void setState(const std::optional<RecordState>& state);
    /// Set to false if there is no room for the figures; the tooltip still has them.
    void setFiguresShown(bool shown) { figures_->setVisible(shown); }
    QString text() const { return figures_->text(); }

private:
    void refresh();

    QToolButton* button_ = new QToolButton(this);
    QLabel* figures_ = mutedLabel({}, this);
    bool writing_ = false;
};

} // namespace usar::widgets
