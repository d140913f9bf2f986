#pragma once

// Icons by name: code points of Font Awesome 4.7 as UTF-8, and behind them those of drawn_icons.hpp. Without
// the icon font the former show as boxes, so text goes with them wherever there is room.

namespace hariko::icon {

inline constexpr unsigned short first = 0xf000, last = 0xf2e0;

inline constexpr const char* select = "\uf245";       // mouse-pointer
inline constexpr const char* orbit = "\uf021";        // refresh
inline constexpr const char* pan = "\uf047";          // arrows
inline constexpr const char* zoom = "\uf00e";         // search-plus
inline constexpr const char* frame = "\uf065";        // expand
inline constexpr const char* vertex = "\uf111";       // circle
inline constexpr const char* edge = "\uf068";         // minus
inline constexpr const char* face = "\uf0c8";         // square
inline constexpr const char* open = "\uf07c";         // folder-open
inline constexpr const char* folder = "\uf07b";       // folder
inline constexpr const char* file = "\uf016";         // file-o
inline constexpr const char* save = "\uf0c7";         // floppy-o
inline constexpr const char* import_file = "\uf090";  // sign-in
inline constexpr const char* export_file = "\uf08b";  // sign-out
inline constexpr const char* undo = "\uf0e2";
inline constexpr const char* redo = "\uf01e";
inline constexpr const char* shown = "\uf06e";   // eye
inline constexpr const char* hidden = "\uf070";  // eye-slash
inline constexpr const char* locked = "\uf023";
inline constexpr const char* unlocked = "\uf09c";
inline constexpr const char* trash = "\uf1f8";
inline constexpr const char* warning = "\uf071";   // exclamation-triangle
inline constexpr const char* error = "\uf06a";     // exclamation-circle
inline constexpr const char* info = "\uf05a";      // info-circle
inline constexpr const char* close = "\uf00d";     // times
inline constexpr const char* up = "\uf062";        // arrow-up
inline constexpr const char* scale = "\uf0b2";     // arrows-alt
inline constexpr const char* mesh = "\uf009";      // th-large
inline constexpr const char* current = "\uf0da";   // caret-right
inline constexpr const char* unfolded = "\uf0d7";  // caret-down
inline constexpr const char* check = "\uf00c";     // check
inline constexpr const char* object = "\uf1b2";    // cube
inline constexpr const char* search = "\uf002";
inline constexpr const char* keyboard = "\uf11c";  // keyboard-o
inline constexpr const char* settings = "\uf013";  // cog
inline constexpr const char* add = "\uf067";       // plus
inline constexpr const char* reset = "\uf0e2";
inline constexpr const char* record = "\uf111";   // circle
inline constexpr const char* picture = "\uf03e";  // picture-o
inline constexpr const char* copy = "\uf0c5";     // files-o
inline constexpr const char* measure = "\uf07e";  // arrows-h

/// All of the above: only these are taken from the font.
inline constexpr const char* of_font[] = {
    select,   orbit,       pan,         zoom,   frame,   vertex, edge,    face,    open,     folder, file,
    save,     import_file, export_file, undo,   redo,    shown,  hidden,  locked,  unlocked, trash,  warning,
    error,    info,        close,       up,     scale,   mesh,   current, check,   object,   search, keyboard,
    settings, add,         reset,       record, picture, copy,   measure, unfolded};

inline constexpr unsigned short extrude_code = 0xf300, inset_code = 0xf301, bevel_code = 0xf302,
                                loop_cut_code = 0xf303, knife_code = 0xf304, lasso_code = 0xf305,
                                mirror_code = 0xf306;
inline constexpr const char* extrude = "\uf300";
inline constexpr const char* inset = "\uf301";
inline constexpr const char* bevel = "\uf302";
inline constexpr const char* loop_cut = "\uf303";
inline constexpr const char* knife = "\uf304";
inline constexpr const char* lasso = "\uf305";
inline constexpr const char* mirror = "\uf306";

}  // namespace hariko::icon
