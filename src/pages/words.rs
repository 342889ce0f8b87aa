//! Words on buttons, tabs and headings of the pages: one word for one thing, on every page.

/// Names each word for the program and for templates, where it stands as `say.submit`.
macro_rules! words {
    ($($(#[$about:meta])* $name:ident = $key:literal: $word:literal;)*) => {
        $($(#[$about])* pub const $name: &str = $word;)*

        /// Every word by its name in templates.
        pub(super) const ALL: &[(&str, &str)] = &[$(($key, $word)),*];
    };
}

words! {
    // Tabs of a course.
    /// The list of assignments.
    ASSIGNMENTS = "assignments": "Assignments";
    /// Who takes part.
    ROSTER = "roster": "Roster";
    /// Problems that the course has written itself.
    PROBLEMS = "problems": "Problems of the course";
    /// How a course is set up.
    SETTINGS = "settings": "Settings";
    /// Who did what.
    HISTORY = "history": "History";
    /// For how long answers are kept.
    RETENTION = "retention": "Retention";

    // Pages of an assignment.
    /// As students see it.
    STUDENT_VIEW = "student_view": "Student view";
    /// Its editor.
    EDIT = "edit": "Edit";
    /// Points of everybody.
    GRADEBOOK = "gradebook": "Gradebook";
    /// How easy each part was.
    STATISTICS = "statistics": "Statistics";
    /// Marks after a correction.
    REGRADE = "regrade": "Regrade";
    /// More time for one student, or for a section.
    EXTENSIONS = "extensions": "Extensions";
    /// Sheets and key on paper.
    PRINT = "print": "Print";

    // What is done with what was typed.
    /// Keeps what is in the fields.
    SAVE = "save": "Save";
    /// Keeps a problem that nobody sees yet.
    SAVE_DRAFT = "save_draft": "Save draft";
    /// Keeps a password.
    SAVE_PASSWORD = "save_password": "Save password";
    /// Keeps an e-mail address.
    SAVE_ADDRESS = "save_address": "Save address";
    /// Sends a link to sign in.
    SEND_LINK = "send_link": "Send me a link";
    /// Keeps more time for a student.
    SAVE_EXTENSION = "save_extension": "Save extension";
    /// Keeps points set by hand.
    SAVE_POINTS = "save_points": "Save points";
    /// Hands in.
    SUBMIT = "submit": "Submit";
    /// What was handed in.
    SUBMITTED = "submitted": "Submitted";
    /// What a form would change, before it does.
    PREVIEW_CHANGES = "preview_changes": "Preview changes";
    /// Makes the changes that were shown.
    APPLY_CHANGES = "apply_changes": "Apply changes";
    /// Shows a problem.
    PREVIEW = "preview": "Preview";
    /// Takes somebody or something in.
    ADD = "add": "Add";
    /// Takes the problems in that are ticked.
    ADD_SELECTED = "add_selected": "Add selected problems";
    /// Takes somebody or something out.
    REMOVE = "remove": "Remove";
    /// Makes a course.
    CREATE_COURSE = "create_course": "Create course";
    /// Saves a table of links by which students sign in.
    SIGN_IN_LINKS = "sign_in_links": "Download sign-in links";
    /// Asks whoever teaches a course for a place in it.
    ASK_FOR_PLACE = "ask_for_place": "Ask for a place";
    /// Makes a code with which people ask.
    NEW_CODE = "new_code": "New code";
    /// Ends it.
    END_CODE = "end_code": "End this code";
    /// Takes those in who are ticked.
    CONFIRM_SELECTED = "confirm_selected": "Confirm selected";
    /// Takes their requests away.
    DECLINE_SELECTED = "decline_selected": "Decline selected";
    /// Finds problems.
    SEARCH = "search": "Search";

    // Practice.
    /// Marks what was typed.
    CHECK = "check": "Check";
    /// The next of the author's hints.
    HINT = "hint": "Hint";
    /// The same where one was shown before.
    ANOTHER_HINT = "another_hint": "Another hint";
    /// A hint on a wrong answer.
    MORE_HELP = "more_help": "More about what is wrong";
    /// The same problem with other numbers.
    NEW_NUMBERS = "new_numbers": "New numbers";
    /// The same after a right answer.
    ANOTHER = "another": "Another like this";

    // What is told.
    /// A form with faults in its fields.
    CHECK_FIELDS = "check_fields": "Not saved yet. Check the fields marked below.";
    /// A form that was kept.
    SAVED = "saved": "Saved.";
}
