// Line edit for one line of protocol text; errors are underlined with waves.
#pragma once

#include <QLineEdit>

#include "core/base/diagnostics.h"

namespace usar::widgets {

/// Fixed-pitch font. The owner decides by an event filter whether Tab completes or moves the focus. GUI thread.
class CommandLine : public QLineEdit {
    Q_OBJECT
public:
    explicit CommandLine(QWidget* parent = nullptr);

    /// Underlines these places. Offsets are bytes of the UTF-8 text; each wave reaches to the end of its word.
    void setDiagnostics(const Diagnostics& diagnostics);
    const Diagnostics& diagnostics() const { return diagnostics_; }
    /// The cursor's position in bytes of the UTF-8 text.
    std::size_t cursorByte() const { return static_cast<std::size_t>(text().left(cursorPosition()).toUtf8().size()); }
    /// Position, in bytes, after the last byte of the word that begins at `offset`.
    std::size_t wordEnd(std::size_t offset) const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Diagnostics diagnostics_;
};

} // namespace usar::widgets
