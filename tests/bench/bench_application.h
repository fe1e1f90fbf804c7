// The application that benchmarks of Qt code need.
#pragma once

#include <QApplication>

namespace usar::bench {

/// One for the whole program, made when the first benchmark asks; no window system is needed to paint into a picture.
inline void needApplication() {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    static int argc = 1;
    static char name[] = "usar-bench";
    static char* argv[] = {name, nullptr};
    // Never taken down: at the end of the program it would meet statics of Qt that are gone already.
    [[maybe_unused]] static auto* const application = new QApplication(argc, argv);
}

} // namespace usar::bench
